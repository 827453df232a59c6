-- Where states.fst comes from: GHDL 2.0 (mcode), which wrote it with
--   ghdl -a states.vhdl && ghdl -e states && ghdl -r states --fst=states.fst
library ieee; use ieee.std_logic_1164.all;
entity states is end;
architecture a of states is
  type state is (idle, run, done);
  signal now_in : state := idle;
  signal line : std_logic := 'U';
  signal bus_of : std_logic_vector(3 downto 0) := "UWLH";
  signal letter : character := 'a';
begin
  process begin
    wait for 5 ns; now_in <= run; line <= '-'; bus_of <= "10-Z"; letter <= 'Q';
    wait for 5 ns; now_in <= done; line <= 'H'; bus_of <= "1010";
    wait;
  end process;
end;
