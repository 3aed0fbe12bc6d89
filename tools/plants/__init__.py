"""Wrong outputs to be planted, by what they are wrong of."""
