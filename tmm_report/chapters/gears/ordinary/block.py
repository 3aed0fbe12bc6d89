"""What looks odd in an ordinary stage as it is stated: nothing yet."""
