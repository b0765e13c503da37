"""What is given away: programs of one scene, the disk, the kit for other programs."""
