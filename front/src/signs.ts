/** Signs over blocks that say what they are called, for those who cannot tell colours apart. */

import { Box3, CanvasTexture, Sprite, SpriteMaterial, SRGBColorSpace, type Mesh } from "three";

const HEIGHT = 0.16;
const GAP = 0.06;
/** m, of a sign and between it and its block. */
const PIXELS = 96;

export function signOver(block: Mesh, word: string): Sprite {
  const canvas = document.createElement("canvas");
  const pen = canvas.getContext("2d")!;
  const font = `600 ${0.62 * PIXELS}px sans-serif`;
  pen.font = font;
  canvas.width = Math.ceil(pen.measureText(word).width + 0.6 * PIXELS);
  canvas.height = PIXELS;
  pen.fillStyle = "#14171b";
  pen.roundRect(0, 0, canvas.width, canvas.height, 0.2 * PIXELS);
  pen.fill();
  pen.fillStyle = "#ffffff";
  pen.font = font;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillText(word, canvas.width / 2, PIXELS / 2);
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const sign = new Sprite(new SpriteMaterial({ map, toneMapped: false }));
  sign.scale.set((HEIGHT * canvas.width) / canvas.height, HEIGHT, 1);
  const top = new Box3().setFromObject(block).max.z;
  sign.position.set(block.position.x, block.position.y, top + GAP + HEIGHT / 2);
  return sign;
}
