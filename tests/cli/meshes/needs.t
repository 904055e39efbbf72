# Meshes by needs: which become coarser, and which scenes the needs belong to.
. "${TOP:-.}/tests/tap.sh"

# Two squares of 200 and 800 faces, which need 2 faces each, at x 0 and 4, as meshes 0 and 1 of one file.
meshgen plane --faces 200 -o small.glb
meshgen plane --faces 800 -o large.glb
unpack small.glb small
unpack large.glb large
# edit FILE.gltf CODE: prints a scene after Perl has changed $s
edit() {
    perl -MJSON::PP -e '
        local $/;
        open my $file, "<", $ARGV[0] or die;
        $s = JSON::PP->new->canonical->decode(<$file>);
        eval $ARGV[1];
        die $@ if $@;
        print JSON::PP->new->canonical->encode($s)' "$1" "$2"
}
# shellcheck disable=SC2016 # Perl's variables
edit small.gltf '
    open my $other, "<", "large.gltf" or die;
    $t = JSON::PP->new->decode(<$other>);
    ($views, $accessors) = (scalar @{$s->{bufferViews}}, scalar @{$s->{accessors}});
    $_->{buffer} = 1 for @{$t->{bufferViews}};
    $_->{bufferView} += $views for @{$t->{accessors}};
    $p = $t->{meshes}[0]{primitives}[0];
    $_ += $accessors for values %{$p->{attributes}}, $p->{indices};
    push @{$s->{$_}}, @{$t->{$_}} for qw(buffers bufferViews accessors meshes);
    $s->{nodes} = [{mesh => 0}, {mesh => 1, translation => [4, 0, 0]}];
    $s->{scenes} = [{nodes => [0, 1]}]' >two.gltf
# Needs of which no view shows anything, so that everything becomes very coarse.
{
    printf 'thing\tindex\tvalue\tunit\ntolerance\t0\t.01\t\nrelative\t0\t1\t\ndarkest\t0\t.5\ttone\n'
    printf 'region-low\t0\t-1\t\nregion-low\t1\t-1\t\nregion-low\t2\t0\t\n'
    printf 'region-side\t0\t.1875\t\nregion-side\t1\t.0625\t\nregion-side\t2\t0\t\nregion-cells\t0\t0\t\n'
} >none.needs
# faces FILE: prints the number of faces of each mesh, in the order of the file
faces() {
    unpack "$1" faces
    # shellcheck disable=SC2016
    edit faces.gltf 'print STDERR join(" ", map {my $n = 0; $n += $s->{accessors}[$_->{indices}]{count} / 3
        for grep {($_->{mode} // 4) == 4} @{$_->{primitives}}; $n} @{$s->{meshes}})' 2>&1 >/dev/null
}

is "two meshes" "$(dirfield -q two.gltf -o full.glb && faces full.glb)" "200 800"
dirfield -q --needs none.needs two.gltf -o coarse.glb
is "both become coarser" "$(faces coarse.glb)" "2 2"
# shellcheck disable=SC2016
edit two.gltf '$s->{nodes} = [reverse @{$s->{nodes}}]' >reversed.gltf
dirfield -q --needs none.needs reversed.gltf -o reversed.glb
is "whatever the order in which nodes draw them" "$(faces reversed.glb)" "2 2"
# shellcheck disable=SC2016
edit two.gltf 'push @{$s->{nodes}}, {mesh => 0, translation => [4, 0, 0]}; push @{$s->{scenes}[0]{nodes}}, 2' >thrice.gltf
dirfield -q --needs none.needs thrice.gltf -o thrice.glb
is "and however many nodes draw one" "$(faces thrice.glb)" "2 2"

# Flat faces, of meshes without normals, would show where they become coarser.
for mesh in 0 1; do
    # shellcheck disable=SC2016
    edit two.gltf "delete \$s->{meshes}[$mesh]{primitives}[0]{attributes}{NORMAL}" >flat.gltf
    dirfield -q --needs none.needs flat.gltf -o flat.glb
    is "mesh $mesh stays without normals, the other becomes coarser" "$(faces flat.glb)" \
        "$(echo 200 2 2 800 | cut -d' ' -f$((1 + 2 * mesh))-$((2 + 2 * mesh)))"
done
# shellcheck disable=SC2016
edit two.gltf '$m = $s->{meshes};
    push @{$m->[0]{primitives}}, $m->[1]{primitives}[0];
    delete $m->[0]{primitives}[0]{attributes}{NORMAL}' >primitives.gltf
dirfield -q --needs none.needs primitives.gltf -o primitives.glb
is "primitives of one mesh, whose borders may touch, stay together" "$(faces primitives.glb)" "1000 2"

# OBJ files have none, and get them: two squares of 200 faces.
perl -e 'for my $x (0, 4) {
        printf "v %g %g 0\n", $x - 1 + .2 * ($_ % 11), .2 * int($_ / 11) - 1 for 0 .. 120;
        printf "f %d %d %d %d\n", map { $_ - 121 } $_, $_ + 1, $_ + 12, $_ + 11 for grep { $_ % 11 < 10 } 0 .. 109;
    }' >two.obj
is "an OBJ file" "$(dirfield -q two.obj -o obj.glb && faces obj.glb)" 400
dirfield -q --needs none.needs two.obj -o obj.glb
is "becomes coarser with the normals that it gets" "$(faces obj.glb)" 4

# Meshes with a direction field stay as fine as they are; dirfield computes it anew.
unpack full.glb full
for mesh in 0 1; do
    # shellcheck disable=SC2016
    edit full.gltf "delete \$s->{meshes}[$mesh]{primitives}[0]{attributes}{_HATCH_DIR}" >field.gltf
    strokegen -q --needs none.needs field.gltf -o field.glb
    is "mesh $mesh becomes coarser without a field, the other stays" "$(faces field.glb)" \
        "$(echo 2 800 200 2 | cut -d' ' -f$((1 + 2 * mesh))-$((2 + 2 * mesh)))"
done
strokegen -q --needs none.needs full.glb -o both.glb
is "with two fields, both stay" "$(faces both.glb)" "200 800"
dirfield -q --needs none.needs full.glb -o anew.glb
is "dirfield lets them become coarser" "$(faces anew.glb)" "2 2"

# Parts that no view shows get no patches. Their texture coordinates are places on the mesh, in tiles.
lapped-param -q --needs none.needs --tile .5 two.gltf -o unseen.glb
unpack unseen.glb unseen
# shellcheck disable=SC2016
is "texture coordinates of what is not seen" "$(edit unseen.gltf '
    open my $file, "<:raw", "unseen.bin" or die;
    my $data = <$file>;
    sub floats {
        my ($index) = @_;
        my ($a, $width) = ($s->{accessors}[$index], {VEC2 => 2, VEC3 => 3}->{$s->{accessors}[$index]{type}});
        my $view = $s->{bufferViews}[$a->{bufferView}];
        my $stride = $view->{byteStride} // 4 * $width;
        return map {[unpack "f<$width", substr $data, ($view->{byteOffset} // 0) + ($a->{byteOffset} // 0) + $stride * $_]}
            0 .. $a->{count} - 1;
    }
    my ($points, $wrong) = (0, 0);
    for (map {$_->{attributes}} map {@{$_->{primitives}}} @{$s->{meshes}}) {
        my @at = floats($_->{POSITION});
        my @uv = floats($_->{TEXCOORD_0});
        for my $i (0 .. $#at) {
            $points++;
            $wrong += abs(.5 * $uv[$i][$_] - $at[$i][$_]) > 1e-6 for 0, 1;
        }
    }
    print STDERR "$wrong of $points"' 2>&1 >/dev/null)" "0 of 8"

# An item of 500 pixels, with at least four patches side by side, has none of over 125.
sed 's/^relative/item-px\t0\t500\t\n&/' none.needs >item.needs
for needs in item none; do
    tamgen -v --size 512 --tones 1 --needs $needs.needs -o /dev/null 2>$needs.said
done
is "a smaller tile is told" "$(grep -h ' a tile of' item.said none.said)" \
    "tamgen: a tile of 128 pixels, not 512: no patch is larger in the pictures"
# Of a mesh that a film deforms, render-gl traces no finer strokes: it gets up to 9 levels, others up to 6. Its middle
# covers so many pixels that any number would be too few.
{
    sed '/^region/d' none.needs
    printf 'unit-px\t31\t1e5\t\n'
    printf 'region-low\t0\t-1\t\nregion-low\t1\t-1\t\nregion-low\t2\t0\t\n'
    printf 'region-side\t0\t.0625\t\nregion-side\t1\t.0625\t\nregion-side\t2\t0\t\n'
    printf 'region-cells\t0\t1\t\nregion-unit-px\t528\t1e5\t\n'
} >near.needs
# shellcheck disable=SC2016
edit small.gltf '$p = $s->{meshes}[0]{primitives}[0];
    $p->{targets} = [{POSITION => $p->{attributes}{POSITION}}];
    push @{$s->{buffers}}, {byteLength => 8, uri => "data:application/octet-stream;base64,AAAAAAAAgD8="}; # 0 and 1
    push @{$s->{bufferViews}}, {buffer => 1, byteLength => 8};
    push @{$s->{accessors}}, {bufferView => $#{$s->{bufferViews}}, componentType => 5126, count => 2, type => "SCALAR",
        min => [0], max => [1]};
    $s->{animations} = [{samplers => [{input => $#{$s->{accessors}}, output => $#{$s->{accessors}}}],
        channels => [{sampler => 0, target => {node => 0, path => "weights"}}]}]' >film.gltf
for file in "small.glb 6" "film.gltf 9"; do
    is "levels of ${file% *}" "$(strokegen -v --needs near.needs --gap 1 --angles 0 ${file% *} 2>&1 >/dev/null |
        grep levels)" "strokegen: ${file#* } of ${file#* } levels are needed"
done

# Needs are those of a scene whose faces have the same box, whatever render-gl adds or leaves out.
[ -x "$BIN/render-gl" ] || { skip "needs of views" "no render-gl"; finish; }
view='--size 160x120 --from 0:20'
# regions FILE [THING]: prints the rows of regions
regions() {
    grep "^region-${2-}" "$1"
}
# shellcheck disable=SC2086 # options are words
render-gl two.gltf $view --needs -o two.needs
# shellcheck disable=SC2086
render-gl two.gltf $view --ground 2 --needs -o ground.needs
regions two.needs >two.regions
regions ground.needs >ground.regions
ok "a ground has no regions" cmp ground.regions two.regions
ok "and its needs are those of the scene" dirfield -q --needs ground.needs two.gltf -o ground.glb
# Regions lie in the scene as the file has it, whichever of its axes points up: seen from above, they are its upper half.
meshgen ellipsoid --faces 2000 -o egg.glb
unpack egg.glb egg
# shellcheck disable=SC2016
edit egg.gltf '$s->{nodes}[0]{scale} = [1, 2, 3]; $s->{nodes}[0]{translation} = [4, 50, 600]' >far.gltf
for axis in y x z; do
    render-gl far.gltf --size 160x120 --up $axis --from 0:90 --needs -o $axis.needs
    # The three numbers of a cell, from 0 to 31, of which the upper half of an axis has the last 16.
    regions $axis.needs unit-px | awk -v axis=$axis '{
            at["x"] = $2 % 32; at["y"] = int($2 / 32) % 32; at["z"] = int($2 / 1024)
            n++; upper += at[axis] >= 15
            for (other in at) if (other != axis) {half += at[other] < 16; total++}
        }
        END {print (n > 100), (upper == n), (half > .4 * total && half < .6 * total)}' >$axis.seen
    is "--up $axis: the upper half of the scene is seen" "$(cat $axis.seen)" "1 1 1"
    is "in the same box" "$(regions $axis.needs low) $(regions $axis.needs side)" \
        "$(regions y.needs low) $(regions y.needs side)"
done
# shellcheck disable=SC2016
edit two.gltf '$s->{meshes}[1]{primitives}[0]{material} = 0;
    $s->{materials} = [{alphaMode => "MASK", pbrMetallicRoughness => {baseColorFactor => [1, 1, 1, .1]}}]' >clear.gltf
# shellcheck disable=SC2086
render-gl -q clear.gltf $view --needs -o clear.needs
is "transparent meshes have no regions" "$(regions clear.needs unit-px | awk '$2 % 32 > 15' | wc -l)" 0
is "but are in their box" "$(regions clear.needs low) $(regions clear.needs side)" \
    "$(regions two.needs low) $(regions two.needs side)"
ok "and the needs are those of the scene" dirfield -q --needs clear.needs clear.gltf -o clear.glb
is "of which the transparent mesh is unseen" "$(faces clear.glb | cut -d' ' -f2)" 2

# Needs of two files in one picture are of neither mesh, which the message says.
# shellcheck disable=SC2086
render-gl -q small.glb large.glb $view --needs -o pair.needs
ok "maps follow the needs of two files" tamgen -q --size 64 --needs pair.needs -o pair.exr
try strokegen --needs pair.needs large.glb -o pair.glb
refused "not meshes" 3 1
is "with what to do" "$(cat .err)" \
    "strokegen: pair.needs: the needs are those of another scene than large.glb: render-gl --needs of this file alone makes them"

# The rows of cells come last: one that is missing, or whose number is cut, changes what is seen.
cells=$(regions two.needs unit-px | wc -l)
is "the number of cells is told" "$(regions two.needs cells)" "$(printf 'region-cells\t0\t%d\t' "$cells")"
sed '$d' two.needs >cut.needs
for command in "dirfield two.gltf" "tamgen --size 64"; do
    # shellcheck disable=SC2086
    try $command --needs cut.needs
    refused "${command%% *}: needs without their last row" 3 1
    is "which are made anew" "$(cat .err)" "${command%% *}: cut.needs: $((cells - 1)) rows 'region-unit-px', not $cells: the file was cut; render-gl SCENE --needs makes it anew"
done
head -c -5 two.needs >cut.needs
try dirfield two.gltf --needs cut.needs -o cut.glb
is "a row whose number is cut" "$status $(cat .err)" \
    "3 dirfield: cut.needs: row $(wc -l <two.needs): fewer than 4 fields"
# A tolerance of a third allows a third of the error.
meshgen torus --faces 8000 -o torus.glb
left_out() {
    render-gl -q torus.glb --needs --tolerance "$1" --size 320x240 -o torus.needs
    dirfield -v --needs torus.needs torus.glb -o fitted.glb 2>&1 | awk '/ faces left out/ {print $2}'
}
few=$(left_out .003) many=$(left_out .01)
ok "a narrower tolerance keeps more faces: $few, $many" test $((many - few)) -gt 1000

# A node's scale changes no mask of patches, as the picture is the same.
meshgen torus --faces 800 -o ring.glb
unpack ring.glb ring
for scale in 1 .1; do
    # shellcheck disable=SC2016
    edit ring.gltf '$s->{nodes}[0]{scale} = [('$scale') x 3]' >scaled.gltf
    render-gl scaled.gltf --size 320x240 --needs -o scaled.needs
    lapped-param -v --needs scaled.needs scaled.gltf -o scaled.glb 2>&1 | grep 'largest patch'
done >masks
is "a mask does not depend on the scale of a node" "$(uniq masks | wc -l) $(grep -c . masks)" "1 2"
# Hills of a thirtieth of their height, on a node that makes them as high: what is left out is measured in the scene.
awk 'BEGIN {
    for (y = 0; y <= 30; y++)
        for (x = 0; x <= 30; x++)
            print "v", x / 15 - 1, .005 * sin(x / 4) * cos(y / 5), 1 - y / 15
    for (y = 0; y < 30; y++)
        for (x = 0; x < 30; x++) {
            a = 31 * y + x + 1
            print "f", a, a + 31, a + 32, a + 1
        }
}' >hills.obj
dirfield -q hills.obj -o hills.glb
unpack hills.glb hills
sed 's/"nodes":\[{/&"scale":[1,30,1],/' hills.gltf >high.gltf
render-gl -q high.gltf --size 320x240 --from 60:20 --needs -o high.needs
dirfield -q --needs high.needs high.gltf -o high.glb
is "an uneven scale does not flatten a mesh" "$(hatchstat coarse --size 320x240 high.gltf high.glb |
    awk -F'\t' 'NR == 2 {print ($2 < 1800), ($3 < 1.5)}')" "1 1"
finish
