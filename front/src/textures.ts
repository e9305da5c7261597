/** Surfaces made by a fixed rule, so that a page needs no picture files. */

import {
  CanvasTexture, MeshLambertMaterial, RepeatWrapping, SRGBColorSpace, type MeshLambertMaterialParameters,
  type Texture,
} from "three";

let looks = 4;

/** Say how often a surface seen at a slant is looked up for each pixel, from now on. */
export function sharpen(times: number): void {
  looks = times;
}

export type Matt = MeshLambertMaterial;

let white: Texture | undefined;

/** A matt surface. All have a texture, if only a white one: each other kind of surface would be one
 * more program to be made ready before the first picture. */
export function matt(parameters: MeshLambertMaterialParameters): Matt {
  white ??= painted(1, (pen) => {
    pen.fillStyle = "#ffffff";
    pen.fillRect(0, 0, 1, 1);
  });
  return new MeshLambertMaterial({ map: white, ...parameters });
}

type Brush = (pen: CanvasRenderingContext2D, size: number, draw: () => number) => void;

/** Poured concrete in slabs of a metre, with a fine joint at every half. */
export function concrete(): Texture {
  return painted(512, (pen, size, draw) => {
    pen.fillStyle = "#cfccc4";
    pen.fillRect(0, 0, size, size);
    speckle(pen, size, draw, 6000, 0.035);
    pen.strokeStyle = "rgba(70, 66, 60, 0.55)";
    pen.lineWidth = 5;
    pen.strokeRect(0, 0, size, size);
    pen.strokeStyle = "rgba(70, 66, 60, 0.16)";
    pen.lineWidth = 2;
    pen.beginPath();
    pen.moveTo(size / 2, 0);
    pen.lineTo(size / 2, size);
    pen.moveTo(0, size / 2);
    pen.lineTo(size, size / 2);
    pen.stroke();
  });
}

/** Plaster, to be tinted by the colour of a body. */
export function plaster(): Texture {
  return painted(256, (pen, size, draw) => {
    pen.fillStyle = "#ffffff";
    pen.fillRect(0, 0, size, size);
    speckle(pen, size, draw, 2500, 0.03);
  });
}

/** Planks with grain, to be tinted. */
export function wood(): Texture {
  return painted(256, (pen, size, draw) => {
    pen.fillStyle = "#ffffff";
    pen.fillRect(0, 0, size, size);
    for (let x = 0; x < size; x += 2) {
      pen.fillStyle = `rgba(60, 30, 5, ${0.02 + 0.16 * draw() ** 2})`;
      pen.fillRect(x, 0, 1 + 2 * draw(), size);
    }
    pen.fillStyle = "rgba(50, 25, 5, 0.55)";
    for (let x = 0; x < size; x += size / 4) pen.fillRect(x, 0, 2, size);
  });
}

/** The rollers of a mecanum wheel as they lie round its tread. */
export function rollers(slant: 1 | -1): Texture {
  const made = painted(128, (pen, size) => {
    pen.fillStyle = "#24272c";
    pen.fillRect(0, 0, size, size);
    pen.strokeStyle = "#8d939c";
    pen.lineCap = "round";
    pen.lineWidth = size / 3.2;
    for (const shift of [-1, 0, 1]) {
      pen.beginPath();
      pen.moveTo((0.5 - 0.45 * slant + shift) * size, -4);
      pen.lineTo((0.5 + 0.45 * slant + shift) * size, size + 4);
      pen.stroke();
    }
  });
  made.repeat.set(9, 1);
  return made;
}

function painted(size: number, brush: Brush): Texture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = size;
  // by the processor: thousands of specks, each a task for the graphics card, hold up the first picture
  const pen = canvas.getContext("2d", { willReadFrequently: true })!;
  brush(pen, size, drawing(20170401));
  const texture = new CanvasTexture(canvas);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = looks;
  return texture;
}

function speckle(
  pen: CanvasRenderingContext2D, size: number, draw: () => number, count: number, strength: number,
): void {
  for (let i = 0; i < count; i += 1) {
    const tone = draw() < 0.5 ? "0, 0, 0" : "255, 255, 255";
    pen.fillStyle = `rgba(${tone}, ${strength * draw()})`;
    const side = 1 + 4 * draw();
    pen.fillRect(size * draw(), size * draw(), side, side);
  }
}

/** The same numbers in [0, 1) on every machine (mulberry32). */
function drawing(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}
