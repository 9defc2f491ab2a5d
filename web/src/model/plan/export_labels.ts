/** The labels of the fields of the export, by the names of its options, which are those of the command line's flags, too. */
export const exportLabels = {
  set: 'Files for the vehicle', number: 'Number of the waypoint list', mission: 'Mission name', firmware: 'Firmware', glider: 'Glider',
  safe: 'Safe places under ice', iceberg_depth_m: 'Deepest iceberg', science: 'Science bands',
} as const;
