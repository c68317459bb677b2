// Colour scales: nine colours at even distances, red, green and blue from 0 to 1.

const stops = (hex) => hex.split(" ").map((h) => [0, 2, 4].map((k) => parseInt(h.slice(k, k + 2), 16) / 255));

export const scales = {
  viridis: stops("440154 472d7b 3b528b 2c728e 21918c 28ae80 5ec962 addc30 fde725"),  // water
  speed: stops("0d2a5c 14539a 2f7fc1 5ca6d6 93c8e4 c5e2ee f3e9a9 f0a54a c8402a"),
  stress: stops("fff3c4 fee391 fec44f fe9929 ec7014 cc4c02 a63603 7f2704 4a1502"),
};

export const runColors = ["#14213d", "#d1495b", "#1b998b", "#8f5fb7", "#b8860b", "#3a86c8"];
export const referenceColors = ["#5b8db8", "#e19c5a", "#6aa56a", "#c76b6b", "#9a7fb5", "#8f766b", "#d490bd", "#8a8a8a",
                                "#b3b347", "#5ab4b8"];

export const css = (rgb) => `rgb(${rgb.map((v) => Math.round(255 * v)).join(",")})`;
