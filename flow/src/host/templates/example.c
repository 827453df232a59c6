// Specula @VERSION@: makes the first packet of @NAME@_packets.hex@REGISTERS_TOO@.
#include <inttypes.h>
#include <stdio.h>

#include "@NAME@.h"

int main(void) {
?span_material|  const struct @NAME@_material material = {
?span_material|@MATERIAL_VALUES@
?span_material|  };
?frame|  const struct @NAME@_frame frame = {
?frame|@FRAME@
?frame|  };
  const struct @NAME@_span span = {
@SPAN@
?span_material|      .material = &material,
  };
  uint@WORD@_t words[@UPPER@_WORDS];
  int number;
?registers|  struct @NAME@_write writes[@UPPER@_WRITES];
?registers|  @NAME@_registers(&frame, writes);
?registers|  for (number = 0; number < @UPPER@_WRITES; ++number) {
?registers|    const struct @NAME@_write write = writes[number];
?registers|    printf("0000%04" PRIx32 "%08" PRIx32 "\n", write.address, write.word);
?registers|  }
  @NAME@_packet(@FRAME_ARGUMENT@&span, words);
  for (number = 0; number < @UPPER@_WORDS; ++number) {
    const int begins = number == 0 ? 2 : 0;
    const int ends = number == @UPPER@_WORDS - 1 ? 1 : 0;
    printf("%x%0@DIGITS@" PRIx@WORD@ "\n", (unsigned)(begins | ends), words[number]);
  }
  return 0;
}
