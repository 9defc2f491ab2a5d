import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { conditionsOfReach, hoursIn } from '../../src/model/reach';

type Properties = Record<string, { properties?: object }>;
const { components } = JSON.parse(readFileSync(new URL('../../../api/openapi/openapi.json', import.meta.url), 'utf8')) as {
  components: { schemas: { PlanInputs: { properties: Properties }; ReachInputs: { properties: Properties } } };
};
const { PlanInputs: plan, ReachInputs: reached } = components.schemas;

describe('hours', () => {
  it('are read as people list them, each once and in order', () => {
    expect(hoursIn('24, 6;12  6')).toEqual([6, 12, 24]);
    expect(hoursIn('1.5')).toEqual([1.5]);
  });

  it('are refused where one is no length of time', () => {
    for (const text of ['', 'six', '6, -1', '0']) expect(hoursIn(text)).toBeUndefined();
  });
});

describe('conditions of reach', () => {
  it('are those of a plan that the server takes for it', () => {
    const ofAPlan = Object.fromEntries(['vehicle', 'margin_m', 'icebergs', 'objective', 'thruster', 'require_battery', 'max_loiter_s'].map((name) => [name, 1]));
    for (const name of Object.keys(ofAPlan)) expect(plan.properties).toHaveProperty(name);

    expect(Object.keys(conditionsOfReach(ofAPlan)).sort()).toEqual(Object.keys(ofAPlan).filter((name) => name in reached.properties).sort());
  });

  it('say of the ice what lets pass, and nothing where it is not asked for', () => {
    const ofIce = Object.fromEntries(Object.keys(plan.properties.under_ice?.properties ?? {}).map((name) => [name, 1]));

    const asked = conditionsOfReach({ under_ice: ofIce }).under_ice ?? {};

    expect(Object.keys(asked).sort()).toEqual(Object.keys(reached.properties.under_ice?.properties ?? {}).sort());
    expect(conditionsOfReach({ under_ice: { escape_plan: true } })).not.toHaveProperty('under_ice');
  });
});
