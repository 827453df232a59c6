#!/bin/sh
# Specula @VERSION_TEXT@: proves what @NAME@_formal.v says of the block, for all times, by
# property-directed reachability. It needs yosys and its yosys-abc.
#
#   sh prove.sh [PROPERTY...]   those alone; without names, all
set -eu
wanted=" $* "
failed=0

# Whether this property is to be proven.
is_wanted() {
  case $wanted in "  " | *" $1 "*) return 0 ;; *) return 1 ;; esac
}

# The top module and the module that has its properties.
for pair in @NAME@_formal:@NAME@_properties @NAME@_regs_formal:@NAME@_regs_formal; do
  top=${pair%:*}
  names=$(sed -n "/^module ${pair#*:}/,/^endmodule/s/^.* \([a-z_]*\): assert.*/\1/p" @NAME@_formal.v)
  any=no
  for name in $names; do if is_wanted "$name"; then any=yes; fi; done
  if [ $any = no ]; then continue; fi
  yosys -q -p "read_verilog -formal @NAME@_formal.v @NAME@_axis.v @NAME@_regs.v;
    setattr -mod -unset keep_hierarchy @NAME@_reset; prep -flatten -top $top;
    memory_map; opt -full; techmap; opt -full; abc -g AND -fast; opt_clean; dffunmap; opt_expr; opt_clean;
    techmap; abc -g AND -fast; opt_clean; tee -q -o $top.properties select -list t:\$assert;
    write_aiger -zinit $top.aig"
  number=0
  while read -r property; do
    name=${property##*[./]}
    output=$number
    number=$((number + 1))
    if ! is_wanted "$name"; then continue; fi
    yosys-abc -c "read_aiger $top.aig; strash; cone -s -O $output; scleanup; lcorr; scorr -F 2; dc2;
      scorr -F 3; pdr -T 600" >prove.log 2>&1
    if grep -q 'Property proved' prove.log; then
      echo "proven: $name"
    elif grep -q 'was asserted in frame' prove.log; then
      echo "FAIL: $name does not hold"
      failed=1
    else
      echo "FAIL: $name was not decided"
      failed=1
    fi
  done <$top.properties
done

if [ $failed = 0 ]; then echo PASS; fi
exit $failed
