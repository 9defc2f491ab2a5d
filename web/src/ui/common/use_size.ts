import { useCallback, useRef } from 'preact/hooks';

/**
 * A reference for an element. `told`, which must stay the same function, is called with the element once it is laid out
 * and whenever its size changes, and with nothing when the element is gone.
 */
export function useSize<E extends HTMLElement>(told: (element: E | undefined) => void): (element: E | null) => void {
  const watch = useRef<ResizeObserver | undefined>(undefined);
  return useCallback((element) => {
    watch.current?.disconnect();
    watch.current = undefined;
    if (!element) {
      told(undefined);
      return;
    }
    watch.current = new ResizeObserver(() => told(element));
    watch.current.observe(element);
  }, [told]);
}
