"""Drawing sheets: letters of strokes, frame and title block, pictures in their places, written as SVG, PDF and DXF."""
