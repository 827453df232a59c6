# Specula @VERSION_TEXT@: packages @NAME@_ip as an IP for Vivado's block designs.
#
#   vivado -mode batch -source @NAME@_ip.tcl
#
# The IP is written to the folder `vivado_ip` beside this file, which is then an IP repository; the
# project `vivado_project` is only needed to make it.
set folder [file dirname [file normalize [info script]]]
set ip_folder [file join $folder vivado_ip]

create_project -force @NAME@_ip [file join $folder vivado_project]
set sources [list]
foreach name {@NAME@.v @NAME@_axis.v @NAME@_regs.v @NAME@_ip.v} {
  lappend sources [file join $folder $name]
}
add_files -fileset sources_1 $sources
?xdc|# The clock that the core was made for counts where the IP is synthesised alone; a design around it has
?xdc|# its own.
?xdc|set constraints [file join $folder @NAME@.xdc]
?xdc|add_files -fileset constrs_1 $constraints
?xdc|set_property used_in {synthesis implementation out_of_context} [get_files $constraints]
set_property top @NAME@_ip [get_filesets sources_1]
update_compile_order -fileset sources_1

ipx::package_project -root_dir $ip_folder -vendor specula -library cores -taxonomy /UserIP \
    -import_files -force
set core [ipx::current_core]
set_property name @NAME@_ip $core
set_property display_name @NAME@_ip $core
set_property description {A shading core with AXI4-Stream and AXI4-Lite, made by Specula} $core
set_property version @VERSION_MAJOR_MINOR@ $core

# Vivado infers interfaces of ports by their names.
ipx::infer_bus_interfaces xilinx.com:interface:axis_rtl:1.0 $core
ipx::infer_bus_interfaces xilinx.com:interface:aximm_rtl:1.0 $core
foreach interface {s_axis m_axis s_axi} {
  if {[llength [ipx::get_bus_interfaces $interface -of_objects $core]] == 0} {
    error "no interface $interface has been inferred"
  }
  ipx::associate_bus_interfaces -busif $interface -clock aclk $core
}
ipx::associate_bus_interfaces -clock aclk -reset aresetn $core

# The registers: 4 KiB.
set map [ipx::get_memory_maps s_axi -of_objects $core]
if {[llength $map] == 0} {
  set map [ipx::add_memory_map s_axi $core]
}
set block [ipx::get_address_blocks -of_objects $map]
if {[llength $block] == 0} {
  set block [ipx::add_address_block registers $map]
}
set_property range 4096 $block
set_property width 32 $block
set_property usage register $block
set_property slave_memory_map_ref s_axi [ipx::get_bus_interfaces s_axi -of_objects $core]

set depth [ipx::get_user_parameters LOG2_DEPTH -of_objects $core]
set_property value_validation_type range_long $depth
set_property value_validation_range_minimum 2 $depth
set_property value_validation_range_maximum 16 $depth

ipx::create_xgui_files $core
ipx::update_checksums $core
ipx::check_integrity $core
ipx::save_core $core
close_project
