      .pixels = @PIXELS@,
      .last = @LAST@,
?positions|      .x = @X@,
?positions|      .y = @Y@,
@SPAN_VALUES@
