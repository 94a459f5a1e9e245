// Numbers as the program shows them: the rules of core/base/short_text and ui/language/shown_numbers.

let decimalPoint = '.';
let units = {};

export function useNumbers(decimal, unitTable) {
  decimalPoint = decimal;
  units = unitTable;
}

const localised = (text) => text.replace('-', '\u2212').replace('.', decimalPoint);

export const unitOf = (dimension) => units[dimension].text;
export const inShownUnit = (value, dimension) => value * units[dimension].factor;

/** Three significant figures without a power of ten. */
function threeFigures(value) {
  if (value === 0) return '0';
  const rounded = Number(value.toPrecision(3)); // 9.996 has one decimal less than 9.99
  const decimals = Math.max(0, 2 - Math.floor(Math.log10(Math.abs(rounded))));
  return value.toFixed(Math.min(decimals, 12));
}

const padded = (number) => String(number).padStart(2, '0');

/** "12.3 ms", "48.5 s", from a minute on "1:48.5", from an hour on "1:02:05". */
export function clockText(seconds) {
  const tenths = Math.round(10 * seconds) / 10;
  if (seconds < 0.1) return seconds > 0 ? localised(`${threeFigures(1000 * seconds)} ms`) : '0 s';
  if (tenths < 60) return localised(`${threeFigures(seconds)} s`);
  if (tenths >= 3600) {
    const whole = Math.round(seconds);
    return `${Math.floor(whole / 3600)}:${padded(Math.floor(whole / 60) % 60)}:${padded(whole % 60)}`;
  }
  const minutes = Math.floor(tenths / 60);
  return localised(`${minutes}:${(tenths - 60 * minutes).toFixed(1).padStart(4, '0')}`);
}

/** What is won or lost [s], as TimeTexts::gain(): "12.3 s", "0.004 s". */
export function gainText(seconds) {
  const tenths = Math.abs(seconds) >= 1;
  return seconds < 60 ? localised(`${seconds.toFixed(tenths ? 1 : 3)} s`) : clockText(seconds);
}

/** The same with its sign, as TimeTexts::change(). */
export const changeText = (seconds) =>
  Math.abs(seconds) < 5e-4 ? '0' : (seconds < 0 ? '\u2212' : '+') + gainText(Math.abs(seconds));

/** "−8.2", as signed_number() with one decimal. */
export function signedPercent(share) {
  const text = (100 * share).toFixed(1);
  const size = text.replace('-', '');
  return Number(text) === 0 ? localised(size) : (text === size ? '+' : '\u2212') + localised(size);
}

/** "8 %", below one percent to a figure that is not 0. */
export function shareText(share) {
  const percent = 100 * share;
  const size = Math.abs(percent);
  if (size >= 1 || size < 1e-3) return localised(`${percent.toFixed(size >= 1 && size < 2 ? 1 : 0)} %`);
  return localised(`${Number(percent.toPrecision(1))} %`);
}

export function numberText(value, dimension, decimals = units[dimension].decimals) {
  const text = inShownUnit(value, dimension).toFixed(decimals);
  return localised(Number(text) === 0 ? text.replace('-', '') : text);
}

export const amountText = (value, dimension, decimals) =>
  `${numberText(value, dimension, decimals)}\u00a0${unitOf(dimension)}`.trim();

/** A number that already is in the unit shown, as ticks and scales have it. */
export const tickText = (number) => localised(String(Number(number.toPrecision(6))));

/** Round ends for a scale up to `top`: 1, 2, 2.5, 3, 4, 5, 6 or 8 times a power of ten. */
export function roundUp(top) {
  if (!(top > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(top));
  const step = [1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10].find((one) => one * power >= top * (1 - 1e-9));
  return step * power;
}
