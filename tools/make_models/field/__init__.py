"""The operative field: an abdomen opened for surgery of the liver, as still scenery."""
