# Smaller work for tests that run lines as users do; such a test includes this file after tests/tap.sh. The commands
# below are then scripts, which add options to those given, make two frames and small pages, and zoom less.
mkdir "$WORK/.small"

# small COMMAND ARGUMENTS
small() {
    cat >"$WORK/.small/$1" <<EOF
#!/bin/bash
words=() operands=() last=
for word; do
    if [[ \$word = -- || \${#operands[@]} -gt 0 ]]; then
        operands+=("\$word")
        continue
    fi
    case \$last=\$word in
    --frames=*) word=2 ;;
    --page=a?) word=a6 ;;
    --animate=zoom=1..4096) word=zoom=1..4 ;;
    esac
    words+=("\$word")
    last=\$word
done
exec "$BIN/$1" "\${words[@]}" $2 "\${operands[@]}"
EOF
    chmod +x "$WORK/.small/$1"
}
small tamgen "--size 128"
small meshgen "--faces 2000"
small render-gl "--size 64x48"
small hatchplan "--size 64x48 --techniques tam,rptam"
small solidgen "--size 16"
PATH=$WORK/.small:$PATH
