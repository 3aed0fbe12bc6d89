"""Many pieces of work over processes or a cluster; nothing of mechanisms is known here."""
