/** The page of the guide for a part of the screen: its address below /guide, and its subject. */
export interface GuidePage {
  address: string;
  about: string;
}

export const guidePages = {
  front: { address: '', about: '' },
  setup: { address: 'planning', about: 'planning routes' },
  reach: { address: 'planning#departure-and-arrival', about: 'reach' },
  plans: { address: 'map#plans', about: 'plans' },
  alternatives: { address: 'planning#alternatives', about: 'alternatives' },
  data: { address: 'data', about: 'data in' },
  layers: { address: 'map#data-and-layers', about: 'layers' },
  waypoints: { address: 'map#waypoints-profile-and-flights', about: 'waypoints' },
  profile: { address: 'map#waypoints-profile-and-flights', about: 'profile' },
  departures: { address: 'planning#departure-and-arrival', about: 'departures' },
  flights: { address: 'test-bed', about: 'test bed' },
  export: { address: 'missions#export', about: 'export' },
  compare: { address: 'planning#compare-evaluate-check-again', about: 'comparing plans' },
  jobs: { address: 'http#jobs', about: 'jobs' },
  login: { address: 'server#signing-in', about: 'signing in' },
} as const satisfies Record<string, GuidePage>;

export type GuideTopic = keyof typeof guidePages;

/** The pages for the folded parts of the set-up, by their titles. */
export const guidePagesOfParts: Record<string, GuidePage> = {
  'Places and areas': { address: 'planning#areas-and-via-points', about: 'areas and via points' },
  'Departure window': { address: 'planning#departure-and-arrival', about: 'departures' },
  Vehicle: { address: 'vehicles', about: 'vehicles' },
  'Icebergs and sea ice': { address: 'under-ice', about: 'under ice' },
  'Uncertainty of currents': { address: 'planning#uncertain-currents', about: 'uncertain currents' },
  Advanced: { address: 'how-it-works#the-search', about: 'the search' },
  Data: { address: 'data', about: 'data in' },
};
