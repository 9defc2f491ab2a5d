import { defineConfig } from '@playwright/test';

const flags = [
  '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync',
];
const launchOptions = { executablePath: process.env['CHROMIUM_BIN'] ?? '/usr/bin/chromium', args: flags };

export default defineConfig({
  testDir: './journeys',
  outputDir: process.env['PLAYWRIGHT_OUTPUT'] ?? '/tmp/floeplan-browser-results',
  // Each with a server of its own.
  workers: Number(process.env['PLAYWRIGHT_WORKERS'] ?? 2),
  // Patient: nothing waits longer than it must, and a busy machine is no fault of the page.
  timeout: 300_000,
  // Long journeys, tagged @long, run with `deploy/test.sh --full`.
  ...(process.env['FLOEPLAN_LONG'] ? {} : { grepInvert: /@long/ }),
  expect: { timeout: 60_000 },
  // The pictures of the guide; guide_pictures.spec.ts makes them.
  snapshotPathTemplate: '{testDir}/../../../web/guide/pictures/{arg}{ext}',
  updateSnapshots: 'none',
  reporter: 'list',
  use: {
    viewport: { width: 1440, height: 900 },
    launchOptions,
    screenshot: 'only-on-failure',
  },
  projects: [
    { name: 'desktop', testIgnore: /narrow/ },
    {
      name: 'no-webgl',
      testMatch: /plan_by_mouse|no_surprises/,
      use: { launchOptions: { ...launchOptions, args: [...flags, '--disable-3d-apis'] } },
    },
    { name: 'phone', testMatch: /narrow/, use: { viewport: { width: 320, height: 640 } } },
  ],
});
