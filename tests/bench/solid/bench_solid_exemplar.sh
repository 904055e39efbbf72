#!/bin/sh
# Measures solidgen --exemplar: time, memory and both distances to the exemplar (hatchstat(1)) over sizes, methods,
# neighbourhoods and iterations, and the fast search against the exhaustive one. The exemplars have 128x128 pixels: cells
# with dark borders and bricks, in colours, and pen strokes that cross, in grey. Distances are of the last run; energy is
# what solidgen -v reports. RUNS, default 5, is the number of runs of which one takes less than some seconds.
set -eu
RUNS=${RUNS:-5}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP

# PNG files, which need no plugin: colour type 2 is RGB, 0 grey.
perl -MCompress::Zlib -e '
    sub png {
        my ($name, $type, $pixel) = @_;
        my $chunk = sub {pack("N", length $_[1]) . $_[0] . $_[1] . pack "N", crc32($_[0] . $_[1])};
        my $rows = join "", map {my $v = $_; "\0" . join "", map {pack "C*", $pixel->($_, $v)} 0 .. 127} 0 .. 127;
        open my $to, ">:raw", "$ARGV[0]/$name.png" or die;
        print $to "\x89PNG\r\n\x1a\n", $chunk->("IHDR", pack "NNC5", 128, 128, 8, $type, 0, 0, 0),
            $chunk->("IDAT", compress($rows)), $chunk->("IEND", "");
    }
    sub random {($state = ($state * 1103515245 + 12345) % 2**31) / 2**31}
    our $state = 1;
    my @places = map {[random() * 160 - 16, random() * 160 - 16, 0.5 + 0.4 * random()]} 1 .. 110;
    png("cells", 2, sub {
        my ($u, $v) = @_;
        my ($near, $next) = sort {$$a[0] <=> $$b[0]} map {[($u - $$_[0])**2 + ($v - $$_[1])**2, $$_[2]]} @places;
        my $edge = (sqrt($$next[0]) - sqrt($$near[0])) / 3.5;
        $edge = 1 if $edge > 1;
        return (255 * $edge * $$near[1], 220 * $edge * $$near[1], 80 * $edge + 13);
    });
    my %tint;
    png("bricks", 2, sub {
        my ($u, $v) = @_;
        my ($row, $grain) = (int($v / 12), 0.9 + 0.1 * random());
        my $across = $u + $row % 2 * 12;
        my $tint = $grain * ($tint{int($across / 24), $row} //= 0.7 + 0.3 * random());
        return $v % 12 < 2 || $across % 24 < 2 ? map {$_ * $grain} 225, 222, 212 : map {$_ * $tint} 170, 85, 55;
    });
    png("strokes", 0, sub {
        my ($u, $v) = @_;
        my ($d) = sort {$a <=> $b} map {my $across = 0.57 * $_ + 0.82 * $v; $across - 8 * int($across / 8)} $u, 128 - $u;
        return 255 * ($d < 1 ? 0 : $d < 2 ? $d - 1 : 1);
    })' "$work"

printf 'method\texemplar\tsize\taxes\tneighborhood\titerations\tseconds\tseconds_min\tseconds_max\tcpu_seconds\tpeak_kib'
printf '\tenergy\thistogram\tneighborhood_distance\n'
# row RUNS METHOD EXEMPLAR SIZE AXES NEIGHBOURHOOD ITERATIONS [OPTION]: METHOD is kopf, pyramid or exhaustive
row() {
    runs=$1 method=$2 picture=$work/$3 size=$4 axes=$5 side=$6 iterations=$7
    printf '%s\t' "$method" "${3%.*}" "$size" "$axes" "$side" "$iterations"
    set -- solidgen --exemplar "$picture" --size "$size" --iterations "$iterations" -o "$work/solid.ktx2"
    case $method in
    kopf) set -- "$@" --neighborhood "$side" --axes "$axes" ;;
    exhaustive) set -- "$@" --neighborhood "$side" --axes "$axes" --exhaustive ;;
    pyramid) set -- "$@" --method pyramid ;;
    esac
    "$MEASURE" "$runs" "$@" --seed @ -v 2>"$work/said" | tr '\n' '\t'
    awk '/difference/ {sum += $NF; n++} END {if (n) printf "%.5f\t", sum / n; else printf "nan\t"}' "$work/said"
    hatchstat solid "$work/solid.ktx2" --reference "$picture" | awk -F'\t' 'NR == 2 {printf "%.5f\t%.5f\n", $14, $18}'
}
for size in 8 16 32 64 128; do
    runs=$RUNS
    [ $size -lt 64 ] || runs=1 # long runs
    row $runs kopf cells.png $size xyz 8 8
    [ $size -eq 128 ] || row $runs kopf strokes.png $size xyz 8 8
    row $RUNS pyramid cells.png $size xyz 0 8
    row $RUNS pyramid strokes.png $size xyz 0 8
done
row 1 kopf bricks.png 64 xyz 8 8
row 1 kopf bricks.png 64 xy 8 8
for exemplar in cells.png bricks.png strokes.png; do
    for side in 4 6 10 12; do
        row $RUNS kopf $exemplar 32 xyz $side 8
    done
    for iterations in 1 2 4 8 16; do
        row $RUNS kopf $exemplar 32 xyz 8 $iterations
    done
    row $RUNS pyramid $exemplar 32 xyz 0 8
    row 1 kopf $exemplar 8 xyz 8 8
    row 1 exhaustive $exemplar 8 xyz 8 8
done
