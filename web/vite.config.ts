import { defineConfig } from 'vitest/config';
import { guide, guideFrame } from './tools/guide/plugin.ts';

export default defineConfig(({ command }) => ({
  base: command === 'build' ? '/app/' : '/',
  build: {
    target: 'es2022',
    outDir: 'dist',
    // Everything is a file of its own: inlined data: scripts and styles would break the content security policy.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    // What several parts need comes in one file: each file more is a request more before the map can be used.
    rolldownOptions: {
      input: { app: 'index.html', guide: guideFrame },
      output: { codeSplitting: { groups: [{ name: 'shared', minShareCount: 2 }] } },
    },
  },
  plugins: [guide()],
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  server: { proxy: apiProxy() },
  test: {
    include: ['tests/unit/**/*.test.ts', 'tests/unit/**/*.test.tsx'],
    environment: 'node',
    server: { deps: { inline: ['proj4'] } },
  },
}));

/** `npm run dev` serves the client itself and hands the API on to a running server. */
function apiProxy(): Record<string, string> {
  const target = process.env['FLOEPLAN_URL'] ?? 'http://127.0.0.1:8080';
  const paths = ['/collections', '/processes', '/jobs', '/datasets', '/vehicles', '/probe', '/map', '/version', '/session',
    '/uploads', '/simulations', '/events', '/missions', '/guide'];
  return Object.fromEntries(paths.map((path) => [path, target]));
}
