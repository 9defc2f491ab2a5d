// node tests/mock/main.mjs [--empty]: serves the built client and the invented sea, for looking at without a store.
import { startMock } from './server.mjs';

const dist = new URL('../../dist/', import.meta.url).pathname;
const port = Number(process.env.PORT ?? 0);
const { url } = await startMock({ dist, port, empty: process.argv.includes('--empty') });
process.stderr.write(`floeplan: serving ${url}\n`);
