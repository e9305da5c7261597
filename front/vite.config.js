import { defineConfig } from "vite";

export default defineConfig({
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
      },
    },
  },
});
