"use strict";
// The bytes of a text in base 91 (base91.h).
function base91(text) {
  const value = new Uint8Array(127);
  let digits = 0;
  for (let c = 33; c <= 126; ++c) if (!"&<\\".includes(String.fromCharCode(c))) value[c] = digits++;
  const bytes = new Uint8Array(Math.ceil(text.length * 14 / 16));
  let size = 0, bits = 0, count = 0;
  const take = (number, width) => {
    bits |= number << count;
    count += width;
    for (; count >= 8; count -= 8, bits >>>= 8) bytes[size++] = bits & 255;
  };
  for (let i = 0; i < text.length; i += 2) {
    if (i + 1 === text.length) {
      take(value[text.charCodeAt(i)], 8 - count);
      break;
    }
    const number = value[text.charCodeAt(i)] + digits * value[text.charCodeAt(i + 1)];
    take(number, (number & 8191) < digits * digits - 8192 ? 14 : 13);
  }
  return bytes.subarray(0, size);
}
// Unpacks the data of a long run, and then starts the page.
(async () => {
  const bytes = base91(document.getElementById("data").textContent);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  window.kinexData = await new Response(stream).text();
  document.getElementById("data").textContent = "";
  const program = document.createElement("script");
  program.textContent = document.getElementById("program").textContent;
  document.body.append(program);
})().catch(error => {
  document.getElementById("name").textContent = "This browser cannot unpack the page: " + error;
});
