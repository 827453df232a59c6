# Specula @VERSION@: makes the first packet of @NAME@_packets.hex@REGISTERS_TOO@.
import @NAME@_ip as block

?material|material = block.Material(
?material|@MATERIAL_VALUES@
?material|)
?frame|frame = block.Frame(
@FRAME_VALUES@
?frame_material|    material=material,
?frame|)
spans = block.Spans(
    pixels=[@PIXELS@],
    last=@LAST@,
?positions|    x=[@X@],
?positions|    y=[@Y@],
@SPAN_VALUES@
?span_material|    material=material,
)
?registers|for address, word in block.registers(frame):
?registers|    print(f"0000{address:04x}{word:08x}")
words = block.packets(@FRAME_ARGUMENT@spans)[0]
for number, word in enumerate(words):
    begins, ends = number == 0, number == block.WORDS - 1
    print(f"{2 * begins + ends:x}{int(word):0@DIGITS@x}")
