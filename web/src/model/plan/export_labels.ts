/** Labels of the fields of the export, by option. The command line's flags have the same names as the options. */
export const exportLabels = {
  set: 'Files for the vehicle', number: 'Number of the waypoint list', mission: 'Mission name', firmware: 'Firmware', glider: 'Glider',
  safe: 'Safe places under ice', iceberg_depth_m: 'Deepest iceberg', science: 'Science bands',
} as const;
