import type { VNode } from 'preact';
import type { GuidePage } from '../../model/guide_pages';

/** A link to the guide's page about the subject beside it, opened in a new tab. */
export function GuideLink({ page: { address, about } }: { page: GuidePage }): VNode {
  return (
    <a class="guide-link" href={address === '' ? '/guide' : `/guide/${address}`} target="_blank" rel="noopener">
      Guide{about !== '' && <span class="visually-hidden">: {about}</span>}
    </a>
  );
}
