@FRAME_VALUES@
?frame_material|      .material = {
?frame_material|@MATERIAL_VALUES@
?frame_material|      },
