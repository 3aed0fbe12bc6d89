"""`tmm-report grade`: what it reads, marks and hands out."""
