(async () => {
  const bytes = (id) => {
    const text = atob(document.getElementById(id).textContent);
    const array = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) array[i] = text.charCodeAt(i);
    return array;
  };
  const inflated = async (id) =>
    new Uint8Array(
      await new Response(
        new Blob([bytes(id)]).stream().pipeThrough(new DecompressionStream('deflate')),
      ).arrayBuffer(),
    );
  window.feedscopeParts = [inflated('feedscope-data'), inflated('feedscope-licences')];
  const script = document.createElement('script');
  script.src = URL.createObjectURL(
    new Blob([await inflated('feedscope-code')], { type: 'text/javascript' }),
  );
  document.body.append(script);
})();
