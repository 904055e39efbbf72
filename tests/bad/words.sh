# words.sh is sourced by scripts that run a command with $folder/$file: makes the folder $work, which lasts as long as the
# script, and replaces the arguments: the word IN is the input, OUT and OUT.ENDING are outputs in $work.
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
count=$#
while [ "$count" -gt 0 ]; do
    word=$1
    shift
    case $word in
    IN) word=$folder/$file ;;
    OUT | OUT.*) word=$work/out${word#OUT} ;;
    esac
    set -- "$@" "$word"
    count=$((count - 1))
done
