// The run to take: the rule of core/analysis/recommendation, on the same figures.

const worthwhileShare = 0.01;
const rounding = 1e-9;

const smallest = (runs, of) => runs.reduce((best, run) => (of(run) < of(best) ? run : best));
const largest = (runs, of) => runs.reduce((best, run) => (of(run) > of(best) ? run : best));

function runsToChooseFrom(choices, within) {
  const competing = choices.filter((run) => run.competes);
  const notRun = Math.min(...competing.map((run) => run.lines_not_run));
  return competing.filter(
    (run) => run.lines_not_run === notRun && (within === null || run.error <= within + rounding),
  );
}

/**
 * `choices`: {time, error, lines_not_run, competes} of each run [s, mm]; `within`: largest error or null.
 * Returns null where no run keeps the bound.
 */
export function recommend(choices, within) {
  const runs = runsToChooseFrom(
    choices.map((choice, run) => ({ ...choice, run })),
    within,
  );
  if (runs.length === 0) return null;
  const fastest = smallest(runs, (run) => run.time);
  const slowest = largest(runs, (run) => run.time);
  const longest = fastest.time * (1 + worthwhileShare);
  const best = runs.reduce(
    (taken, run) =>
      run.time <= longest &&
      (run.error < taken.error || (run.error === taken.error && run.time < taken.time))
        ? run
        : taken,
    fastest,
  );
  const gain = slowest.time - best.time;
  return {
    run: best.run,
    against: slowest.run,
    gain,
    gainShare: slowest.time > 0 ? gain / slowest.time : 0,
    reason:
      runs.length === 1
        ? 'only'
        : slowest.time <= longest
          ? 'no-difference'
          : best.time === fastest.time
            ? 'fastest'
            : 'smallest-error-within-1-percent',
  };
}

/** The run that results are about: leading_run() of core/analysis/study/recommendation; null without a choice. */
export function leadingRun(choices, within) {
  const taken = recommend(choices, within);
  if (taken) return taken.run;
  const runs = runsToChooseFrom(choices.map((choice, run) => ({ ...choice, run })), null);
  if (runs.length === 0) return null;
  const least = Math.min(...runs.map((run) => run.error));
  return smallest(runs.filter((run) => run.error === least), (run) => run.time).run;
}

/** Why no other run can be chosen where recommend() has the reason 'only'; `choices` also have `other_model`. */
export function whyOnly(choices, within) {
  const competing = choices.filter((run) => run.competes);
  const beyond = competing.filter((run) => within !== null && run.error > within + rounding);
  const ofOtherModels = choices.some((run) => run.other_model);
  if (competing.length === 1) return ofOtherModels ? 'of-machine' : 'possible';
  if (beyond.length + 1 < competing.length) return 'possible';
  return ofOtherModels ? 'within-bound-of-machine' : 'within-bound';
}
