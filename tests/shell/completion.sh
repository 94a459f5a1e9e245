# bash completes commands, options and values; zsh and fish understand what is written for them.
set -euo pipefail
feedscope=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
touch part.nc
for shell in bash zsh fish; do
  "$feedscope" help --completion $shell --out $shell
done

# expect "WORDS SO FAR" WORD...: what bash offers for the last of the words.
. ./bash
expect() {
  local words=$1 word
  shift
  read -ra COMP_WORDS <<<"$words"
  [[ $words == *' ' ]] && COMP_WORDS+=('')
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) COMPREPLY=()
  _feedscope
  for word; do
    [[ " ${COMPREPLY[*]} " == *" $word "* ]] || { echo "bash: '$words' offers '${COMPREPLY[*]}', not '$word'"; exit 1; }
  done
}
expect 'feedscope sim' simulate
expect 'feedscope simulate --mach' --machine
expect 'feedscope simulate --machine sp' spinner-mvc850
expect 'feedscope simulate --machine ' part.nc hermle-c800u
expect 'feedscope simulate part.nc --model ' essid ward optimal
expect 'feedscope compare ' part.nc
expect 'feedscope simulate --unit ' mm inch
expect 'feedscope machines im' import
expect 'feedscope machines import --o' --out
expect 'feedscope help sim' simulate
expect 'feedscope simulate --dialect si' sinumerik
expect 'feedscope report --language ' en fr

command -v zsh >/dev/null && zsh -n zsh
awk '/_arguments/ { rest = 0 } /^ *.[*][:]/ { if (++rest > 1) exit 1 }' zsh ||
  { echo 'zsh: a command has two arguments that take all the rest'; exit 1; }
if command -v fish >/dev/null; then
  offered=$(HOME=$work fish --no-config -c 'source fish; complete -C "feedscope simulate --machine he"; complete -C "feedscope sim"')
  grep -q hermle-c800u <<<"$offered" || { echo "fish offers: $offered"; exit 1; }
  grep -q simulate <<<"$offered" || { echo "fish offers: $offered"; exit 1; }
fi
if command -v zsh >/dev/null; then
  mkdir functions && cp zsh functions/_feedscope
  zsh -f -c 'fpath=($PWD/functions $fpath); autoload -U compinit; compinit -u -d '"$work"'/dump; whence -w _feedscope' | grep -q function
fi
