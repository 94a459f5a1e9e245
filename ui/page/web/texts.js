// Texts in the language of the page, by their English: ui/page/page_texts lists them.

let table = {};

export function useTexts(texts) {
  table = texts;
}

/** The text with %1, %2 ... replaced. */
export const tr = (english, ...values) =>
  (table[english] ?? english).replace(/%([1-9])/g, (whole, number) => values[number - 1] ?? whole);
