import { beforeEach, describe, expect, it } from 'vitest';
import { caller, forbids, lock, locked, may, signedIn, unlock, whyNot } from '../../src/model/login';
import { dialog, notice } from '../../src/model/screen';

describe('login', () => {
  beforeEach(() => {
    caller.value = undefined;
    locked.value = undefined;
    dialog.value = undefined;
  });

  it('lets everyone do everything where the server knows nobody by name', () => {
    expect(may('admin')).toBe(true);
    unlock({ name: 'local', role: 'admin' });
    expect(may('admin')).toBe(true);
    expect(signedIn.value).toBeUndefined();
  });

  it('grants what a role may and no more, and says why not', () => {
    unlock({ name: 'vera', role: 'viewer' });
    expect(may('viewer')).toBe(true);
    expect(may('pilot')).toBe(false);
    expect(whyNot('viewer', 'Looking')).toBeUndefined();
    expect(whyNot('pilot', 'Planning')).toBe('Planning needs the role pilot; you are signed in as vera, viewer.');
    expect(forbids('admin', 'Removing')).toBe(true);
    expect(notice.value).toContain('Removing needs the role admin');
    unlock({ name: 'otto', role: 'pilot' });
    expect(forbids('pilot', 'Planning')).toBe(false);
    expect(may('admin')).toBe(false);
  });

  it('asks for a token, and tells a login that has ended from none at all', () => {
    lock();
    expect(locked.value).toBe('first');
    expect(dialog.value).toBe('login');
    unlock({ name: 'otto', role: 'pilot' });
    expect(locked.value).toBeUndefined();
    lock();
    expect(locked.value).toBe('ended');
  });
});
