"""What each command does, one room a command; what it says goes through `talk.Talk`, and only `cli` prints."""
