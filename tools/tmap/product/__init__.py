"""Products for users: programs of one scene, the disk, the kit for other programs."""
