# The man page names every command and option, and man has nothing to say against it.
set -euo pipefail
feedscope=$1
page=$(mktemp)
trap 'rm -f "$page"' EXIT
"$feedscope" help --man --out "$page"
text=$(MANWIDTH=200 MANROFFSEQ='' man -l "$page" 2>/dev/null | col -bx)
for command in simulate compare check machines models lessons help; do
  grep -qE "^ +$command$" <<<"$text" || { echo "no command $command"; exit 1; }
  for option in $("$feedscope" "$command" --help | grep -oE '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+'); do
    grep -qF -- "$option" <<<"$text" || { echo "no option $option of $command"; exit 1; }
  done
done
warnings=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 >/dev/null)
[[ -z $warnings ]] || { echo "$warnings"; exit 1; }
