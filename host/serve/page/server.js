// Questions and orders to the server that the page is from: relative to the page, whose address has
// the token.
async function reply(what, options) {
  const response = await fetch(what, { cache: "no-store", signal: AbortSignal.timeout(10000), ...options });
  if (!response.ok) throw new Error(`${what}: ${response.status}`);
  return response;
}

export async function ask(what) {
  return (await reply(what)).json();
}

export async function order(what) {
  return (await reply(what, { method: "POST" })).json();
}

/** A picture: width, height, channels, number, values; null if there is none yet. */
export async function askPicture(what) {
  const response = await reply(what);
  if (response.status === 204) return null;
  const bytes = await response.arrayBuffer();
  const [width, height, channels, number] = new Uint32Array(bytes, 0, 4);
  return { width, height, channels, number, values: new Float32Array(bytes, 16) };
}
