behavior_name=yo
<start:b_arg>
  b_arg: d_target_depth(m) 180.  # région
  b_arg: d_pitch_value(X) -.4538
<end:b_arg>
