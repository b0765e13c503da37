"""Products for users: programs of one scene, its profile, the disk, the kit for other programs."""
