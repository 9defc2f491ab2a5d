import { execFileSync, spawn, type ChildProcess } from 'node:child_process';
import { cpSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** A path that run.sh gives: the program, the built page, or the store with the demonstration data that every server copies. */
const given = (name: string): string => {
  const value = process.env[name];
  if (!value) throw new Error(`${name} is not set: run tests/browser/run.sh.`);
  return value;
};

export interface Server {
  url: string;
  /** Runs the program on the server's store, as whoever runs the server does; its standard output. */
  run: (...words: string[]) => string;
  stop: () => Promise<void>;
}

/** The words that name a store of its own at the database server beside which the journeys run, as a copy of the seed. */
function storeAtServer(server: string, folder: string, empty: boolean): string[] {
  const schema = `journey_${String(process.pid)}_${String(++schemas)}`;
  execFileSync('psql', [server, '--quiet', '--command', `CREATE SCHEMA ${schema}`]);
  const address = `${server}&options=-csearch_path%3D${schema}`;
  if (!empty) {
    const seed = `${folder}-seed`; // of its own: a store that is copied is locked
    cpSync(given('FLOEPLAN_SEED'), seed, { recursive: true });
    execFileSync(given('FLOEPLAN_BIN'), ['store', 'copy', `sqlite:${seed}`, address]);
  }
  return ['--data', folder, '--store', address];
}
let schemas = 0;

/** The words that name a store of its own: a copy of the demonstration data, or nothing. */
function ownStore(folder: string, empty: boolean): string[] {
  const server = process.env.FLOEPLAN_TEST_SERVER;
  if (server) return storeAtServer(server, folder, empty);
  if (!empty) cpSync(given('FLOEPLAN_SEED'), folder, { recursive: true });
  return ['--data', folder];
}

/** Starts a server on a port and a store of its own: a copy of the demonstration data, or nothing. */
export async function startServer({ empty = false } = {}): Promise<Server> {
  const program = given('FLOEPLAN_BIN');
  const folder = mkdtempSync(join(tmpdir(), 'floeplan-browser-'));
  const store = ownStore(join(folder, 'store'), empty);
  const words = [...store, 'serve', '--listen', '127.0.0.1:0', '--web', given('FLOEPLAN_WEB')];
  const server = spawn(program, words, { stdio: ['ignore', 'ignore', 'pipe'] });
  const url = await addressOf(server);
  return {
    url,
    run: (...more) => execFileSync(program, [...store, ...more], { encoding: 'utf8' }),
    stop: async () => {
      const ended = new Promise((resolve) => server.once('exit', resolve));
      server.kill();
      await ended;
      rmSync(folder, { recursive: true, force: true });
    },
  };
}

/** Where it listens, as its first words say. */
function addressOf(server: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    let said = '';
    server.stderr?.setEncoding('utf8').on('data', (text: string) => {
      said = (said + text).slice(-10_000);
      const found = /^floeplan: serving (http:\/\/[^ \n]*?)\/?\s/m.exec(said);
      if (found?.[1]) resolve(found[1]);
    });
    server.once('exit', (code) => reject(new Error(`The server ended with ${String(code)} before it listened:\n${said}`)));
  });
}
