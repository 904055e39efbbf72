# Many meshes, objects and frames take no more memory than they have to: what serves one of them serves the next. Limits
# are a tenth over what is needed, in MB; where a result is kept for each object, that is most of it.
. "${TOP:-.}/tests/tap.sh"

# copies KIND COUNT <FILE: the mesh of a GLB file many times, in a square: as nodes of one mesh, or of a mesh each
copies() {
    perl -MJSON::PP -0777 -e '
        my ($kind, $count) = @ARGV;
        binmode $_ for *STDIN, *STDOUT;
        my $file = <STDIN>;
        my $length = unpack "x12 V", $file;
        my $scene = decode_json(substr $file, 20, $length);
        my @numbers = 0 .. $count - 1;
        $scene->{meshes} = [map { {%{$scene->{meshes}[0]}, name => "mesh $_"} } @numbers] if $kind eq "meshes";
        $scene->{nodes} = [map { {mesh => $kind eq "meshes" ? $_ : 0, translation => [3 * ($_ % 10), 0, -3 * int($_ / 10)]} }
            @numbers];
        $scene->{scenes}[0]{nodes} = \@numbers;
        my $json = encode_json($scene);
        $json .= " " x (-length($json) % 4);
        my $rest = substr $file, 20 + $length;
        print pack("a4 V3 a4", "glTF", 2, 20 + length($json) + length $rest, length $json, "JSON"), $json, $rest;
    ' "$1" "$2"
}

# takes MB COMMAND ...: checks that a command ends within this memory
takes() {
    megabytes=$1
    shift
    ok "at most $megabytes MB: $*" "$@" -q -j2 --max-memory "${megabytes}M"
}

small() { takes "$@" --size 96x64 --samples 1 -o "picture%d.png"; }

meshgen teapot --faces 1500 | dirfield -q | copies meshes 20 >meshes.glb
takes 9 dirfield meshes.glb -o field.glb
takes 52 lapped-param meshes.glb -o lapped.glb
takes 11 meshfit meshes.glb -o fitted.glb
takes 11 strokegen --levels 3 meshes.glb -o strokes.glb
awk 'BEGIN {for (i = 0; i < 1000; i++) {
    for (c = 0; c < 4; c++) print "v", 2 * (i % 40) + c % 2, 2 * int(i / 40) + int(c / 2), i % 7
    print "f -4 -3 -1 -2"
}}' >parts.obj
takes 4 strokegen --gap 0.02 --levels 2 parts.obj -o strokes.glb
takes 5 hatchstat mesh meshes.glb meshes.glb meshes.glb
takes 11 hatchstat field meshes.glb meshes.glb meshes.glb

tamgen -q --size 64 --levels 2 -o map.exr
meshgen teapot --faces 3000 | dirfield -q >one.glb
copies nodes 100 <one.glb >objects.glb
strokegen -q --levels 2 objects.glb -o strokes.glb
small 22 render-gl objects.glb -t gouraud --lines all --shadows 0.02 --haloes 3 --ground 3
small 3 render-gl objects.glb -t gouraud --zoom 9
small 18 render-gl objects.glb --show field
small 22 render-gl objects.glb -T map.exr
small 22 render-gl objects.glb -t rptam
small 22 render-gl objects.glb -t strokes
small 4 render-gl objects.glb -t solid
small 27 render-gl strokes.glb -t traced
small 36 render-gl strokes.glb -t traced --zoom 30
takes 72 render-gl objects.glb -t gouraud --lines all --size 96x64 -o drawing.svg
small 3 render-gl one.glb -t gouraud --lines all --shadows 0.02 --frames 30 --turntable
small 4 render-gl one.glb -t strokes --frames 30 --turntable
takes 3 render-gl one.glb -t gouraud --lines all --frames 30 --turntable --size 96x64 -o drawing%d.svg
finish
