"""The shared arithmetic of mechanism theory: numpy arrays in, numpy arrays out, nothing of the project above."""
