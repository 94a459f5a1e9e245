// Elements of the page. Texts become text, never markup.

const svgNamespace = 'http://www.w3.org/2000/svg';

function filled(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (name === 'style') Object.assign(node.style, value);
    else if (value === true) node.setAttribute(name, '');
    else if (value !== undefined && value !== null && value !== false) node.setAttribute(name, value);
  }
  node.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return node;
}

export const el = (tag, attributes = {}, ...children) =>
  filled(document.createElement(tag), attributes, children);

export const svg = (tag, attributes = {}, ...children) =>
  filled(document.createElementNS(svgNamespace, tag), attributes, children);

/** A canvas with the pixels of the screen, cleared; null while it has no size. */
export function prepared(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const { clientWidth: width, clientHeight: height } = canvas;
  if (width === 0 || height === 0) return null;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext('2d');
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return { context, width, height };
}

/** Colour of a variable of the style. */
export const themeColour = (node, name) => getComputedStyle(node).getPropertyValue(name).trim();

/** A piece of the line of a run. */
export function lineSample(run) {
  return svg(
    'svg',
    { width: 30, height: 8, class: 'sample', 'aria-hidden': 'true' },
    svg('line', {
      x1: 0,
      y1: 4,
      x2: 30,
      y2: 4,
      stroke: run.colour,
      'stroke-width': 2,
      'stroke-dasharray': run.dashes.map((dash) => 2 * dash).join(' '),
    }),
  );
}
