import type { VNode } from 'preact';
import type { GuidePage } from '../../model/guide_pages';

/** Leads to the page of the guide on what it stands beside, in a tab of its own. */
export function GuideLink({ page: { address, about } }: { page: GuidePage }): VNode {
  return (
    <a class="guide-link" href={address === '' ? '/guide' : `/guide/${address}`} target="_blank" rel="noopener">
      Guide{about !== '' && <span class="visually-hidden">: {about}</span>}
    </a>
  );
}
