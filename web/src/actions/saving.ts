import { request } from './http';

/** The file name that the server gives an answer. */
const named = /filename="([^"]+)"/;

/**
 * Saves the server's answer as a file. A refusal is thrown as an `ApiError`: left to the browser, a link would save the
 * refusal in place of the file.
 */
export async function saveFile(address: string): Promise<void> {
  const response = await request(address);
  const name = named.exec(response.headers.get('content-disposition') ?? '')?.[1] ?? '';
  const content = URL.createObjectURL(await response.blob());
  const link = document.createElement('a');
  link.href = content;
  link.download = name;
  link.click();
  URL.revokeObjectURL(content);
}
