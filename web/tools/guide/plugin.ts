import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { join } from 'node:path';
import type { Plugin } from 'vite';
import { framed, readGuide, searchText } from './guide.ts';

const root = fileURLToPath(new URL('../../..', import.meta.url));

/** The frame of all pages, which Vite builds with its script and style sheet. */
export const guideFrame = 'guide.html';

/** Writes the guide to dist/guide: each page in the built frame, the pictures, and what the search looks through. */
export function guide(): Plugin {
  return {
    name: 'floeplan-guide',
    apply: 'build',
    enforce: 'post',
    generateBundle: {
      order: 'post',
      handler(_, bundle) {
        const frame = bundle[guideFrame];
        if (frame?.type !== 'asset') throw new Error(`${guideFrame} was not built.`);
        const read = readGuide(root);
        const emit = (fileName: string, source: string | Uint8Array): void => {
          this.emitFile({ type: 'asset', fileName: `guide/${fileName}`, source });
        };
        for (const page of read.pages) emit(`${page.name || 'index'}.html`, framed(String(frame.source), read, page));
        for (const [name, file] of read.pictures) emit(`pictures/${name}`, readFileSync(join(root, file)));
        emit('search.json', searchText(read));
        Reflect.deleteProperty(bundle, guideFrame);
      },
    },
  };
}
