# hatchplan --draw: options of render-gl that hatchplan does not set itself, and nothing else.
. "${TOP:-.}/tests/tap.sh"
meshgen plane --faces 2 -o plane.glb
few="--size 16x12 --techniques rptam,solid --style pencil"
while IFS='|' read -r draw words; do
    try hatchplan $few plane.glb --from 40:20 --ground 3 --draw "$draw"
    is "--draw '$draw'" "$status $(head -n 1 .err)" "2 hatchplan: --draw: $words"
done <<'END'
--samples 1|hatchplan itself sets the option --samples of render-gl
--up z --size=10x10|hatchplan itself sets the option --size of render-gl
-t gouraud|hatchplan itself sets the option --technique of render-gl
--style ink|hatchplan itself sets the option --style of render-gl
--look plain|hatchplan itself sets the option --look of render-gl
--solid a.ktx2|hatchplan itself sets the option --solid of render-gl
--from 10:10|hatchplan itself sets the option --from of render-gl
--ground 2|hatchplan itself sets the option --ground of render-gl
--times victim.tsv|hatchplan itself sets the option --times of render-gl
-o victim.png|hatchplan itself sets the option --output of render-gl
-vovictim.png|hatchplan itself sets the option --output of render-gl
--up z -j 2|hatchplan itself sets the option --threads of render-gl
--up z plane.glb|'plane.glb' is no option of render-gl: scenes are operands of hatchplan
--pixel-light plane.glb|'plane.glb' is no option of render-gl: scenes are operands of hatchplan
-|'-' is no option of render-gl: scenes are operands of hatchplan
--up z --|-- ends the options of render-gl, after which scenes follow: want options alone
--up z --help|render-gl draws nothing with --help
-V|render-gl draws nothing with --version
END
is "nothing was drawn or made" "$(ls)" plane.glb
try hatchplan $few plane.glb --draw '--unknown'
is "an unknown option" "$status $(head -n 1 .err)" "2 hatchplan: render-gl: unknown option --unknown"
try hatchplan --size 16x12 --techniques rptam plane.glb --tolerance 1 --make \
    --draw '--from 10:10 --pixel-light --paper "#ffeedd" --light -30:10 --up=z --look watercolor -v'
is "options that it does not set" "$status $(grep -c -e "--up=z --look watercolor -v" .out)" "0 1"
finish
