import { lock, unlock, type Caller } from '../model/login';
import { announce } from '../model/screen';
import * as api from './client';
import { resumePlanning } from './planning';
import { refresh } from './session';

/** Asks the server who the user is and reads the store; asks for a token if the server needs one. Call at start. */
export async function enter(): Promise<void> {
  try {
    unlock(await api.whoAmI());
  } catch (error) {
    if (error instanceof api.ApiError && error.problem.status === 401) {
      lock();
      return;
    }
    // Any other failure shows when the store is read.
  }
  await refresh();
  void resumePlanning();
}

/** Sends a token to the server; returns why it was refused, or undefined. */
export async function signIn(token: string): Promise<string | undefined> {
  let who: Caller;
  try {
    who = await api.logIn(token);
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
  unlock(who);
  announce(`Signed in as ${who.name}, ${who.role}.`);
  await refresh();
  void resumePlanning();
  return undefined;
}

/** Logs out; returns the failure, if any. The page is reloaded, so that no data stay on the screen. */
export async function signOut(): Promise<string | undefined> {
  try {
    await api.logOut();
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
  location.reload();
  return undefined;
}
