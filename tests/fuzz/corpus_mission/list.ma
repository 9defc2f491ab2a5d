behavior_name=goto_list
# c
<start:b_arg>
	b_arg: num_legs_to_run(nodim) -2
	b_arg: start_when(enum) 0
	b_arg: list_stop_when(enum) 7
	b_arg: list_when_wpt_dist(m) 500
	b_arg: initial_wpt(enum) 0
	b_arg: num_waypoints(nodim) 2
<end:b_arg>
<start:waypoints>
-7348.0000	3917.0000
-7329.0000	3818.0000
<end:waypoints>
