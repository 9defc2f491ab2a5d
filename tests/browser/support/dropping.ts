import { expect, type Page } from '@playwright/test';

/** Drops files on the page as a browser does. */
export async function drop(page: Page, files: { name: string; text: string }[]): Promise<void> {
  const transfer = await page.evaluateHandle((given) => {
    const held = new DataTransfer();
    for (const { name, text } of given) held.items.add(new File([text], name));
    return held;
  }, files);
  await page.dispatchEvent('#map', 'dragover', { dataTransfer: transfer });
  await expect(page.getByText('Drop the files to add them to the store')).toBeVisible();
  await page.dispatchEvent('#map', 'drop', { dataTransfer: transfer });
  await expect(page.getByText('Drop the files to add them to the store')).toBeHidden();
}
