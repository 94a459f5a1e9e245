# The study of a folder of programs over many processes or machines: one of the programs is broken and is named, the table
# of the rest has the bytes of one made in one go.
#
#   nightly_study.sh FEEDSCOPE SOURCE BUILD parallel|slurm
set -euo pipefail
feedscope=$1 source_dir=$2 way=$4
script=$source_dir/resources/examples/nightly_study.sh
. "$(dirname "$0")/slurm_on_loopback.sh"

skip() {
  echo "$*: skipped"
  exit 77
}
case $way in
  parallel)
    parallel --version 2>/dev/null | grep -q 'GNU parallel' || skip "GNU parallel is not installed"
    ;;
  slurm)
    missing=$(slurm_is_installed) || skip "$missing"
    [[ $EUID -eq 0 ]] || skip "a node of Slurm needs root"
    ;;
  *)
    echo "usage: nightly_study.sh FEEDSCOPE SOURCE BUILD parallel|slurm" >&2
    exit 2
    ;;
esac

work=$(mktemp -d)
trap 'stop_slurm; rm -rf "$work"' EXIT
export FEEDSCOPE=$feedscope HOME=$work
programs=$work/programs
mkdir "$programs"
cp "$source_dir"/resources/programs/{essid_table1.nc,fanuc_flange.nc,lesson_corners.nc,heidenhain_plate.h} "$programs"
printf 'G1 X20 F3000\nY20\n' >"$programs/two words.nc"
{ printf 'G1' && head -c 100 /dev/zero && printf 'X1'; } >"$programs/noise.nc"

fail() {
  echo "$*"
  tail -n 20 "$work"/*.{out,err} 2>/dev/null || true
  exit 1
}

# expect CODE NAME COMMAND...: its output goes to NAME.out and NAME.err.
expect() {
  local expected=$1 name=$2 code=0
  shift 2
  "$@" >"$work/$name.out" 2>"$work/$name.err" || code=$?
  [[ $code -eq $expected ]] || fail "$name: exit code $code, not $expected"
}

# expect_merged RESULTS NAME: all but the broken program are in the table, and it is the one of $work/reference.
expect_merged() {
  local results=$1 name=$2
  grep -qE '^  noise\.nc: .*is not a text file.*exit code 2' "$work/$name.err" || fail "$name does not name noise.nc"
  [[ $(grep -c '^  ' "$work/$name.err") -eq 1 ]] || fail "$name names more than noise.nc"
  [[ $(ls "$results" | grep -c '\.json$') -eq 5 ]] || fail "$name: not 5 programs in '$results'"
  cmp "$work/reference/study.csv" "$results/study.csv" || fail "$name: another table than in one go"
}

over_parallel() {
  ls "$programs"/* | parallel --bar --jobs 2 "$script" --one '{}' "$work/results"
}

# The array as the head of the script has it; $SLURM_ARRAY_TASK_ID is for the shell of the job.
submit() {
  local folder=$1
  shift
  sbatch "$@" --array="1-$(ls "$folder" | wc -l)" --output="$work/job-%a.out" \
    --wrap "'$script' --job \$SLURM_ARRAY_TASK_ID '$folder' '$work/results'"
}

# A job that its cluster ends before it is done is named too.
cancelled_job() {
  local job failed=$work/results/freeform_finish.nc.failed
  mkdir "$work/long"
  cp "$source_dir/resources/programs/freeform_finish.nc" "$work/long"
  job=$(submit "$work/long" --parsable)
  within 30 test -e "$failed" || fail "the job that was to be cancelled did not start"
  scancel "$job"
  within 60 no_jobs || fail "the cancelled job still runs"
  expect 1 cancelled sh "$script" --merge "$work/results"
  grep -q '^  freeform_finish\.nc: did not finish' "$work/cancelled.err" || fail "the cancelled program is not named"
  cmp "$work/reference/study.csv" "$work/results/study.csv" || fail "the cancelled program is in the table"
}

no_jobs() {
  [[ -z $(squeue --noheader) ]]
}

expect 1 in_one_go env JOBS=1 "$script" "$programs" "$work/reference"
expect_merged "$work/reference" in_one_go
if [[ $way == parallel ]]; then
  expect 1 parallel over_parallel # as many as failed
else
  start_slurm "$work/slurm" || fail "Slurm did not start"
  expect 1 slurm submit "$programs" --wait # the worst exit code of all jobs
fi
expect 1 merge sh "$script" --merge "$work/results"
expect_merged "$work/results" merge
[[ $way == parallel ]] || cancelled_job
