import { readFileSync } from "node:fs";
import { defineConfig } from "vite";

/** The licence of what is built in goes where it goes. */
const licence = {
  name: "licence",
  generateBundle() {
    const source = readFileSync("node_modules/three/LICENSE", "utf8");
    this.emitFile({ type: "asset", fileName: "three-licence.txt", source });
  },
};

export default defineConfig({
  plugins: [licence],
  build: {
    outDir: "../omnistudy/view/built",
    emptyOutDir: true,
    target: "es2022",
    chunkSizeWarningLimit: 1000,
    reportCompressedSize: false,
    rollupOptions: {
      input: "src/main.ts",
      output: {
        entryFileNames: "view.js",
        assetFileNames: "view[extname]",
        codeSplitting: false,
        postBanner: "/*! Holds three.js, copyright three.js authors, MIT licence. */",
      },
    },
  },
});
