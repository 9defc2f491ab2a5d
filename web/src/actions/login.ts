import { lock, unlock, type Caller } from '../model/login';
import { announce } from '../model/screen';
import * as api from './client';
import { resumePlanning } from './planning';
import { refresh } from './session';

/** Asks who one is and reads what the store holds; waits for a token where the server wants one. Called at start. */
export async function enter(): Promise<void> {
  try {
    unlock(await api.whoAmI());
  } catch (error) {
    if (error instanceof api.ApiError && error.problem.status === 401) {
      lock();
      return;
    }
    // Whatever else is wrong shows when the store is read.
  }
  await refresh();
  void resumePlanning();
}

/** Shows a token to the server; why it was not taken, if so. */
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

/** Ends the login. The page starts anew, so that nothing of the store stays on the screen. */
export async function signOut(): Promise<string | undefined> {
  try {
    await api.logOut();
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
  location.reload();
  return undefined;
}
