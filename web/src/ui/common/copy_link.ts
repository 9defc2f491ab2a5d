import { tell } from '../../model/screen';
import { addressOfView } from '../../model/shared_view';

/** Copies a link to what the screen shows, or says where to copy it from if the clipboard cannot be used. */
export async function copyLink(): Promise<void> {
  try {
    await navigator.clipboard.writeText(addressOfView());
    tell('The link to this view was copied.');
  } catch {
    tell('The address bar holds the link to this view; copy it from there.');
  }
}
